import { sectorFromRecord } from '../../client_scripts/core/sectorRecord.js';
import { streetRecords } from './streetRecords.js';

/**
 * The street of streetRecords with a house north of sector 0: a hall, 8 x 6 m, behind a door at x = 20 ... 21, y = 10, and a
 * closet, 3 x 4 m, behind the hall.
 */
export function houseRecords() {
  const records = streetRecords(3), [street] = records;
  const hall = {
    id: 'hall', kind: 'interior', name: 'Hall', origin: [20, 13], box: [16, 10, 24, 16.3], shapes: 9, visible: ['hall'], neighbours: [], gates: [],
    ground: [[[16, 10.3], [20, 10.3], [20, 10], [21, 10], [21, 10.3], [24, 10.3], [24, 16.2], [20.5, 16.2], [20.5, 16.3], [19.5, 16.3], [19.5, 16.2], [16, 16.2]]],
  };
  const closet = {
    id: 'closet', kind: 'interior', name: '', origin: [20, 18], box: [18.5, 16.3, 21.5, 20.4], shapes: 7, visible: ['closet'], neighbours: [], gates: [],
    ground: [[[18.5, 16.4], [19.5, 16.4], [19.5, 16.3], [20.5, 16.3], [20.5, 16.4], [21.5, 16.4], [21.5, 20.4], [18.5, 20.4]]],
  };
  const place = ({ id, origin, box }) => ({ to: id, origin, box });
  street.doors = [{ id: 'd', twin: 'd-in', line: [[21, 10], [20, 10]], ...place(hall) }];
  hall.doors = [
    { id: 'd-in', twin: 'd', line: [[20, 10], [21, 10]], ...place(street) },
    { id: 'e', twin: 'e-in', line: [[20.5, 16.3], [19.5, 16.3]], ...place(closet) }];
  closet.doors = [{ id: 'e-in', twin: 'e', line: [[19.5, 16.3], [20.5, 16.3]], ...place(hall) }];
  return [...records, hall, closet];
}

/** id -> sector of the core. */
export function houseSectors() {
  return new Map(houseRecords().map(record => [record.id, sectorFromRecord(record)]));
}
